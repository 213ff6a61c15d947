# What each printed error does, one panel each, printed against mended: ./lab study handout_errata
width = 16; height = 16.5
load "report/figures/style.gp"
set multiplot layout 3, 3 margins 0.115, 0.985, 2.1 / height, 1 - 0.8 / height spacing 0.115, 2.6 / height
unset key
set tics font ",8"
wanted(number, form, value) = strcol("erratum") eq number && strcol("form") eq form ? value : NaN
running(value) = strcol("state") eq "runs" ? value : NaN
lost(value) = strcol("state") eq "lost" ? value : NaN
# The forms of erratum `number`: the printed one last, so that it lies on top.
curves(number) = sprintf("plot for [k = 1:4] csv using (wanted('%s', word('mended other another printed', k), \
  column('t'))):(running(column('value'))) with lines linetype word('1 6 7 2', k) linewidth 2, \
  for [k = 1:4] csv using (wanted('%s', word('mended other another printed', k), column('t'))):(lost(column('value'))) \
  with points pointtype 2 pointsize 1 linewidth 2.5 linecolor rgb 'black'", number, number)
set xlabel "t [s]" offset 0, 0.7 font ",9"
set title offset 0, -0.5 font ",9"
set ylabel offset 1, 0 font ",9"

set title "1  explicit Euler: a ball"; set ylabel "energy / start"
set yrange [0.98:*]; set xtics 20
set xrange [0:60]
eval(curves("1"))

set title "2  ρ_0 = m/(π h^2)"; set ylabel "median ρ/ρ_0"
set yrange [0.8:1.6]; set xtics 1
set xrange [0:3]
eval(curves("2"))

eval(logarithmic_y)
set title "3  pressure from i to j"; set ylabel "largest speed / c"
set yrange [1e-3:10]; set xtics 0.01
set xrange [0:0.03]
eval(curves("3"))

set title "4  viscosity from i to j"; set ylabel "dissipated / start"
set yrange [1e-16:1e-4]; set ytics 1e4
set xrange [0:0.03]
eval(curves("4"))

set title "5  viscosity times ρ, no 1/r"
set yrange [1e-16:1]; set xtics 0.2; set ytics 1e4
set label 1 "in pixels" at graph 0.97, 0.12 right font ",9" textcolor rgb yellow
set xrange [0:0.5]
eval(curves("5"))
unset label; set ytics 10

set title "6  τ = h/c"; set ylabel "largest speed / c"
set yrange [1e-3:10]; set xtics 0.5
set label 1 "0.4 h/c" at graph 0.09, 0.9 left font ",9" textcolor rgb yellow
set label 2 "0.1 h/c" at graph 0.72, 0.9 center font ",9" textcolor rgb grey
set label 3 "Verlet, h/c" at graph 0.97, 0.12 right font ",9" textcolor rgb blue
set xrange [0:2]
eval(curves("6"))
unset label

set title "7  walls that only reflect"; set ylabel "largest speed / √(gH)"
set yrange [1e-4:10]; set xtics 1
set xrange [0:4]
eval(curves("7"))

set title "8  a sum up to the surface"; set ylabel "error of pressure"
set yrange [1e-3:100]; set xtics 1
set label 1 "p ≥ 0" at graph 0.5, 0.3 center font ",9" textcolor rgb yellow
set xrange [0:2]
eval(curves("8"))
unset label

unset logscale y; set ytics autofreq; set format y "%h"
set title "9  gravity counted twice"; set ylabel "height [m]"
set yrange [0:1.1]; set xtics 0.1
set xrange [0:0.32]
eval(curves("9"))

eval(shared_key)
plot NaN notitle, keyentry with lines linetype 2 linewidth 2 title "as printed", \
  keyentry with lines linetype 1 linewidth 2 title "mended", \
  keyentry with points pointtype 2 pointsize 1 linewidth 2.5 linecolor rgb "black" title "lost"
unset multiplot
