# A standing wave: its swing, and the errors of frequency and decay against the spacing: ./lab study standing_wave
width = 16; height = 12.5
load "report/figures/style.gp"
load "report/figures/convergence.gp"
reynolds = "inviscid 500 100 50 inviscid"
width_of(k) = k == 5 ? 3 : 2
when(part, k) = strcol("part") eq part && strcol("Re") eq word(reynolds, k) && column("h_over_dx") == width_of(k)
eval(shared_panels(2, 2))
unset key
set xlabel "t/T" offset 0, 0.6; set ylabel "amplitude / the first" offset 0.5, 0
set title "the swing, H/dx = 40 (grey: exact)" offset 0, -0.5
set xrange [0:2]; set yrange [-1.1:1.1]; set ytics 0.5
plot for [k = 1:4] csv using (when("curve", k) ? column("periods") : NaN):"amplitude" \
       with lines linetype k, \
     for [k = 1:4] csv using (when("curve", k) ? column("periods") : NaN):"exact_amplitude" \
       with lines linecolor rgb grey_line linewidth 1
eval(resolution_axis("H/dx", 16, 150)); set xtics (20, 30, 40, 60, 80, 120)
do for [quantity in "frequency decay"] {
  set title quantity . " (grey: dx^2)"; set ylabel "relative error"; set yrange [1e-4:0.3]
  plot 20. / x**2 with lines linecolor rgb grey_line linewidth 1, \
    for [k = (quantity eq "decay" ? 2 : 1):(quantity eq "decay" ? 4 : 5)] csv \
      using (when("run", k) ? column("H_over_dx") : NaN):quantity . "_error" \
      with linespoints linetype k
}
set title "cost (grey: dx^{-3})"; set ylabel "processor s per s" ; set yrange [0.01:100]
plot x**3 / 3e5 with lines linecolor rgb grey_line linewidth 1, \
  for [k = 1:5] csv using (when("run", k) ? column("H_over_dx") : NaN):"seconds" \
    with linespoints linetype k
names = "inviscid 'Re = 500' 'Re = 100' 'Re = 50' 'inviscid, h/dx = 3'"; load "report/figures/key.gp"
unset multiplot
