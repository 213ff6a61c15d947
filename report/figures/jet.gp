# A jet on a plate and a tank that drains, against free streamlines: ./lab study jet
width = 16; height = 12
load "report/figures/style.gp"
load "report/figures/convergence.gp"
when(part, name) = strcol("part") eq part && strcol("flow") eq name
eval(keyed_panels(2, 2))
eval("set key top right " . small_key)
set xlabel "x/d" offset 0, 0.6; set ylabel "C_p" offset 0.5, 0
set title "pressure on the plate" offset 0, -0.5
set xrange [0:2.5]; set yrange [0:1.1]; set ytics 0.2
plot csv using (when("curve", "jet") && column("resolution") == 20 ? column("x") : NaN):"exact" \
       with lines linecolor rgb grey_line linewidth 1.5 title "free streamlines", \
     for [n in "5 20"] csv using (when("curve", "jet") && column("resolution") == n ? column("x") : NaN):"y" \
       with points linetype (n eq "5" ? 2 : 1) title "d/dx = " . n
set title "a tank that drains"; set xlabel "t [s]"; set ylabel "(h/h_0)^{1/2}"
eval("set key bottom left " . small_key)
set xrange [0:1.6]; set xtics 0.4; set yrange [0.65:1]; set ytics 0.1
plot csv using (when("curve", "draining") ? column("x") : NaN):"exact" \
       with lines linecolor rgb grey_line linewidth 1.5 title "Torricelli, C_c = 0.611", \
     csv using (when("curve", "draining") ? column("x") : NaN):"y" with points linetype 1 title "b/dx = 10"
eval(resolution_axis("d/dx", 4, 50)); set xtics (5, 10, 20, 40)
eval("set key bottom left " . small_key)
set title "errors of the jet (grey: dx)"; set ylabel "relative error"; set yrange [1e-4:1]
plot 0.5 / x with lines linecolor rgb grey_line linewidth 1 notitle, \
  csv using (when("run", "jet") ? column("resolution") : NaN):"error" with linespoints linetype 1 title "force, mean", \
  csv using (when("run", "jet") ? column("resolution") : NaN):"shaking" with linespoints linetype 2 title "force, rms", \
  csv using (when("run", "jet") ? column("resolution") : NaN):"profile_error" with linespoints linetype 3 title "C_p, rms"
eval("set key top left " . small_key)
set title "cost (grey: dx^{-3})"; set ylabel "processor s per s"; set yrange [0.01:100]
set xlabel "d/dx, b/dx"
plot x**3 / 2e4 with lines linecolor rgb grey_line linewidth 1 notitle, \
  csv using (when("run", "jet") ? column("resolution") : NaN):"seconds" with linespoints linetype 1 title "jet", \
  csv using (when("run", "draining") ? column("resolution") : NaN):"seconds" with linespoints linetype 2 title "draining"
unset multiplot
