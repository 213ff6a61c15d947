# Drops with surface tension against Rayleigh, Laplace and Young: ./lab study capillarity
width = 16; height = 12
load "report/figures/style.gp"
load "report/figures/convergence.gp"
when(part, name, h) = strcol("part") eq part && strcol("case") eq name && column("h_over_dx") == h
eval(keyed_panels(2, 2))
eval("set key top right horizontal " . small_key)
set xlabel "t [ms]" offset 0, 0.6; set ylabel "stretch over the first" offset 0.5, 0; set ytics 0.5
set title "a drop that swings, R/dx = 25" offset 0, -0.5
set xrange [0:24]; set yrange [-1.1:1.5]
plot csv using (when("curve", "swinging", 3) ? column("t") : NaN):"exact_swing" \
       with lines linecolor rgb grey_line linewidth 3 title "Rayleigh", \
     csv using (when("curve", "swinging", 3) ? column("t") : NaN):"swing" \
       with lines linetype 1 title "h/dx = 3", \
     csv using (when("curve", "swinging", 4) ? column("t") : NaN):"swing" \
       with lines linetype 2 title "4"
set logscale x; set xlabel "R/dx"; set xrange [8:65]; set xtics (10, 15, 25, 35, 50)
set title "contact angle (grey: wanted)"; set ylabel "degrees"; set yrange [45:135]; set ytics 30; unset key
plot for [angle in "60 90 120"] real(angle) with lines linecolor rgb grey_line linewidth 1, \
     for [k = 1:3] csv using (when("run", "plate " . word("60 90 120", k), 3) ? column("R_over_dx") : NaN):"angle" \
       with linespoints linetype k
eval(resolution_axis("R/dx", 8, 65))
eval("set key bottom left vertical maxrows 2 " . small_key)
set title "errors, and what does not rest"; set ylabel "relative error, Ca"; set yrange [1e-6:1]; set ytics 100
plot csv using (when("run", "round", 3) ? column("R_over_dx") : NaN):"error" \
       with linespoints linetype 1 title "pressure jump", \
     csv using (when("run", "swinging", 3) ? column("R_over_dx") : NaN):"error" \
       with linespoints linetype 2 title "period", \
     csv using (when("run", "swinging", 4) ? column("R_over_dx") : NaN):"error" \
       with linespoints linetype 6 title "period, h/dx = 4", \
     csv using (when("run", "round", 3) ? column("R_over_dx") : NaN):"capillary_number" \
       with linespoints linetype 3 title "parasitic Ca"
eval("set key top left vertical maxrows 4 " . small_key)
set title "cost (grey: dx^{-3.5})"; set ylabel "processor s per ms"; set yrange [1e-3:10]; set ytics autofreq
plot x**3.5 / 8e5 with lines linecolor rgb grey_line linewidth 1 notitle, \
     for [k = 1:3] csv using (when("run", word("round swinging 'plate 60'", k), 3) ? column("R_over_dx") : NaN):(column("seconds")/1000) \
       with linespoints linetype k title word("round swinging 'plate 60'", k)
unset multiplot
