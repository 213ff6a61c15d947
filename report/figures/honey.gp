# A viscous liquid between plates: its profiles as it starts (grey: the series), and their error against the spacing: ./lab study honey
width = 16; height = 12.5
load "report/figures/style.gp"
load "report/figures/convergence.gp"
when(part, flow) = strcol("part") eq part && strcol("sweep") eq "spacing" && strcol("flow") eq flow
eval(shared_panels(2, 2))
unset key
set xlabel "u/U" offset 0, 0.6; set ylabel "y/d" offset 0.5, 0
set xrange [0:1]; set yrange [0:1]
instants = "0.0225 0.045 0.1125 0.225"
do for [flow in "couette poiseuille"] {
  set title (flow eq "couette" ? "Couette" : "Poiseuille") . ", d/dx = 20" offset 0, -0.5
  plot for [k = 1:4] csv \
         using (when("curve", flow) && column("instant") == word(instants, k) ? column("exact_speed") : NaN):"y" \
         with lines linecolor rgb grey_line linewidth 1, \
       for [k = 1:4] csv \
         using (when("curve", flow) && column("instant") == word(instants, k) ? column("speed") : NaN):"y" \
         with points linetype k
}
eval(resolution_axis("d/dx", 8, 100)); set xtics (10, 20, 40, 80)
eval("set key bottom left " . small_key)
set title "largest error (grey: dx^2)"; set ylabel "over U"; set yrange [1e-4:0.1]
plot 1 / x**2 with lines linecolor rgb grey_line linewidth 1 notitle, \
  for [flow in "couette poiseuille"] csv using (when("run", flow) ? column("d_over_dx") : NaN):"error" \
    with linespoints linetype (flow eq "couette" ? 5 : 6) title flow eq "couette" ? "Couette" : "Poiseuille"
eval("set key top left " . small_key)
set title "cost (grey: dx^{-4})"; set ylabel "processor s per s"; set yrange [0.001:100]
plot x**4 / 6e6 with lines linecolor rgb grey_line linewidth 1 notitle, \
  for [flow in "couette poiseuille"] csv using (when("run", flow) ? column("d_over_dx") : NaN):"seconds" \
    with linespoints linetype (flow eq "couette" ? 5 : 6) title flow eq "couette" ? "Couette" : "Poiseuille"
names = "'nu t/d^2 = 0.0225' '0.045' '0.1125' '0.225'"; load "report/figures/key.gp"
unset multiplot
