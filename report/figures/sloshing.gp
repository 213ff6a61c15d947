# A tank that sways, and one that rolls: the surface at a wall, and its error against the spacing: ./lab study sloshing
width = 16; height = 12
load "report/figures/style.gp"
load "report/figures/convergence.gp"
when(part, name) = strcol("part") eq part && strcol("scene") eq name
eval(keyed_panels(2, 2))
eval("set key top left maxrows 4 " . small_key)
set xlabel "t/T_1" offset 0, 0.6; set ylabel "elevation / largest" offset 0.5, 0
set xrange [0:3]; set yrange [-1.2:2.8]; set ytics -1, 1
do for [name in "sloshing rolling"] {
  set title name offset 0, -0.5
  plot csv using (when("curve", name) && column("H_over_dx") == 40 ? column("periods") : NaN):"exact_elevation" \
         with lines linecolor rgb grey_line linewidth 3 title "linear theory", \
       for [n in "10 40"] csv \
         using (when("curve", name) && column("H_over_dx") == n ? column("periods") : NaN):"elevation" \
         with lines linetype (n eq "10" ? 2 : 1) title "H/dx = " . n
}
eval(resolution_axis("H/dx", 8, 100)); set xtics (10, 20, 40, 80)
eval("set key bottom left maxrows 2 " . small_key)
set title "largest error; dotted: of w_1 (grey: dx)"; set ylabel "relative error"; set yrange [1e-6:1]; set ytics 100
plot 0.5 / x with lines linecolor rgb grey_line linewidth 1 notitle, \
  for [k = 1:2] csv using (when("run", word("sloshing rolling", k)) ? column("H_over_dx") : NaN):"largest_error" \
    with linespoints linetype k title word("sloshing rolling", k), \
  for [k = 1:2] csv using (when("run", word("sloshing rolling", k)) ? column("H_over_dx") : NaN):"frequency_error" \
    with linespoints linetype k dashtype 3 notitle
eval("set key top left maxrows 4 " . small_key)
set title "cost (grey: dx^{-3})"; set ylabel "processor s per s"; set ytics autofreq; set yrange [0.01:100]
plot x**3 / 1e5 with lines linecolor rgb grey_line linewidth 1 notitle, \
  for [k = 1:2] csv using (when("run", word("sloshing rolling", k)) ? column("H_over_dx") : NaN):"seconds" \
    with linespoints linetype k title word("sloshing rolling", k)
unset multiplot
