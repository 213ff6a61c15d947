# Error against time step, one panel per case: ./lab study orders
width = 16; height = 12
load "report/figures/style.gp"
eval(logarithmic_x); eval(logarithmic_y)
set xlabel "dt [s]" offset 0, 0.6; set ylabel "rms error [m]" offset 1, 0
set xrange [1e-5:0.2]; set yrange [1e-17:1]; set ytics 1e-16, 1e4
eval(panels(2, 2))
unset key
do for [name in "'fall with drag' 'fall without drag' 'clamped bounces' 'located bounces'"] {
  set title name offset 0, -0.5
  plot for [k = 1:words(schemes)] csv \
    using (strcol("case") eq name ? only("scheme", word(schemes, k), column("dt")) : NaN):"error" \
    with linespoints linetype k
}
names = scheme_names; load "report/figures/key.gp"
unset multiplot
