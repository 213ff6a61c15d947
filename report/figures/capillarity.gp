# Drops with surface tension against Rayleigh, Laplace and Young: ./lab study capillarity
width = 16; height = 12.5
load "report/figures/style.gp"
load "report/figures/convergence.gp"
when(part, name, h) = strcol("part") eq part && strcol("case") eq name && column("h_over_dx") == h
eval(shared_panels(2, 2))
unset key
set xlabel "t [ms]" offset 0, 0.6; set ylabel "stretch / the first" offset 0.5, 0; set ytics 0.5
set title "a swing, R/dx = 25 (grey: Rayleigh)" offset 0, -0.5
set xrange [0:24]; set yrange [-1.1:1.1]
plot csv using (when("curve", "swinging", 3) ? column("t") : NaN):"exact_swing" \
       with lines linecolor rgb grey_line linewidth 3, \
     for [k = 2:3] csv using (when("curve", "swinging", k + 1) ? column("t") : NaN):"swing" with lines linetype k
set logscale x; set xlabel "R/dx"; set xrange [8:65]; set xtics (10, 15, 25, 35, 50)
set title "contact angle (grey: wanted)"; set ylabel "degrees"; set yrange [45:135]; set ytics 30
plot for [angle in "60 90 120"] real(angle) with lines linecolor rgb grey_line linewidth 1, \
     for [k = 1:3] csv using (when("run", "plate " . word("60 90 120", k), 3) ? column("R_over_dx") : NaN):"angle" \
       with linespoints linetype 7
eval(resolution_axis("R/dx", 8, 65))
set title "errors, and what does not rest"; set ylabel "relative error, Ca"; set yrange [1e-6:1]; set ytics 100
plot csv using (when("run", "round", 3) ? column("R_over_dx") : NaN):"error" with linespoints linetype 1, \
     for [k = 2:3] csv using (when("run", "swinging", k + 1) ? column("R_over_dx") : NaN):"error" with linespoints linetype k, \
     csv using (when("run", "round", 3) ? column("R_over_dx") : NaN):"capillary_number" with linespoints linetype 4
set title "cost (grey: dx^{-3.5})"; set ylabel "processor s per ms"; set yrange [1e-3:10]; set ytics autofreq
plot x**3.5 / 1.2e6 with lines linecolor rgb grey_line linewidth 1, \
     csv using (when("run", "round", 3) ? column("R_over_dx") : NaN):(column("seconds") / 1000) with linespoints linetype 1, \
     for [k = 2:3] csv using (when("run", "swinging", k + 1) ? column("R_over_dx") : NaN):(column("seconds") / 1000) \
       with linespoints linetype k
names = "'round (pressure)' 'swinging (period)' 'h/dx = 4' 'parasitic Ca'"; load "report/figures/key.gp"
unset multiplot
