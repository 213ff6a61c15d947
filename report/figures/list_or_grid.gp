# What a step costs, and whom it tests, against the number of discs: ./lab study list_or_grid
width = 16; height = 8
load "report/figures/style.gp"
set datafile missing NaN  # the rows of the curves alternate
eval(logarithmic_x); eval(logarithmic_y)
set xlabel "discs n" offset 0, 0.6
set xrange [7:2e6]
eval(panels(2, 1))
unset key
series(name, value) = only("search", name, value)

# Grey: n and n^2, through the last point of either curve.
last_n = 1; last_seconds = 1; last_list_n = 1; last_list_seconds = 1
note(name, n, seconds) = name eq "grid" ? (last_n = n, last_seconds = seconds, 0) : \
  (last_list_n = n, last_list_seconds = seconds, 0)
stats csv using (note(strcol("search"), column("particles"), column("seconds"))) nooutput

set ylabel "time of a step [s]" offset 1.7, 0
set label 1 "n^2" at last_list_n * 1.7, last_list_seconds * 2.4 textcolor rgb grey
set label 2 "n" at last_n * 0.55, last_seconds * 0.18 textcolor rgb grey
power(x, exponent, n, seconds) = x > 300 && x < 1.5 * n ? seconds * (x / n)**exponent : NaN
plot power(x, 2, last_list_n, last_list_seconds) with lines linecolor rgb "#B0B0B0" linewidth 1, \
  power(x, 1, last_n, last_seconds) with lines linecolor rgb "#B0B0B0" linewidth 1, \
  csv using "particles":(series("list", column("seconds"))) with linespoints linetype 1, \
  csv using "particles":(series("grid", column("seconds"))) with linespoints linetype 2
unset label
set ylabel "others tested for each disc" offset 0.6, 0
plot csv using "particles":(series("list", column("pairs_tested"))) with linespoints linetype 1, \
  csv using "particles":(series("grid", column("pairs_tested"))) with linespoints linetype 2, \
  csv using "particles":(series("grid", column("neighbours"))) with linespoints linetype 3
names = "'list: all pairs' 'grid of cells' 'others that touch it'"; load "report/figures/key.gp"
unset multiplot
