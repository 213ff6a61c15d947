# Error against processor time, one setting changed at a time: ./lab study work_precision_sph
# Dotted: PySPH as it was measured before, at R/dx = 20, 40, 80.
width = 16; height = 16
load "report/figures/style.gp"
set datafile missing NaN  # lines go on past the rows of others
families = "resolution kernel h/dx density integrator CFL c"
ours(case, value) = strcol("case") eq case && strcol("varied") ne "PySPH" ? value : NaN
family(case, name, value) = strcol("case") eq case && strcol("varied") eq name ? value : NaN
peer(setting, value) = strcol("varied") eq "PySPH" && strcol("setting") eq setting ? value : NaN
# The points by rising cost, a line of two words each; the least error so far along them is the Pareto front.
sorted(case, what, block) = sprintf("set print %s; print 'cpu least'; unset print; \
  set table %s append; plot csv using (ours('%s', column('cpu'))):(ours('%s', column('%s'))) \
  smooth unique; unset table", block, block, case, case, what)
eval(sorted("elliptical drop", "b_largest", "$b"))
eval(sorted("elliptical drop", "energy_largest", "$energy"))
eval(sorted("still water", "pressure_largest", "$pressure"))
eval(sorted("still water", "speed_largest", "$speed"))

eval(logarithmic_x); eval(logarithmic_y)
set xlabel "processor time [s]" offset 0, 0.4
set multiplot layout 2, 2 margins 0.105, 0.985, 4.0 / height, 1 - 0.9 / height spacing 0.125, 2.6 / height
unset key
set tics font ",9"
set title offset 0, -0.4; set ylabel offset 0.8, 0
number(k) = real(word(strcol(1), k))
front(block) = sprintf("%s using (number(1)):(least = (number(2) < least ? number(2) : least)) \
  with steps linecolor rgb '#B8B8B8' linewidth 5", block)
marks(case, what) = sprintf("for [k = 1:words(families)] csv using \
  (family('%s', word(families, k), column('cpu'))):'%s' with points linetype k pointsize 0.7", case, what)
default(case, what) = sprintf("csv using (family('%s', 'resolution', column('cpu'))): \
  (family('%s', 'resolution', column('%s'))) with lines linetype 1", case, case, what)
peers(what) = sprintf("csv using (peer('measured here', column('cpu'))):'%s' with linespoints \
  linecolor rgb 'black' pointtype 2 pointsize 0.9 linewidth 1.6", what)
published(what) = sprintf("csv using (1e-9):(peer('as published', column('%s'))):(1e9):(0) with vectors nohead \
  linecolor rgb '#909090' linewidth 0.8 dashtype 3", what)

panel(case, what, block, others) = "least = 1e9; plot " . front(block) . ", " . others . default(case, what) . ", " . \
  marks(case, what)

set xrange [0.001:1000]; set yrange [1e-3:1]
set title "Elliptical drop: semi-axis b"; set ylabel "largest relative error"
eval(panel("elliptical drop", "b_largest", "$b", published("b_largest") . ", " . peers("b_largest") . ", "))
set title "Elliptical drop: kinetic energy"
eval(panel("elliptical drop", "energy_largest", "$energy", published("energy_largest") . ", " . \
  peers("energy_largest") . ", "))
set title "Still water: pressure"; set ylabel "largest L_2 error / L_2"
set xrange [0.05:100]
eval(panel("still water", "pressure_largest", "$pressure", ""))
set title "Still water: motion"; set ylabel "largest speed / √(gH)"
eval(panel("still water", "speed_largest", "$speed", ""))

eval(shared_key)
set tmargin at screen 2.3 / height
set key maxrows 3 samplen 1.5 font ",9"
plot NaN notitle, for [k = 1:words(families)] keyentry with points linetype k pointsize 0.9 title word(families, k), \
  keyentry with points pointtype 2 pointsize 0.9 linewidth 1.6 linecolor rgb "black" title "PySPH", \
  keyentry with lines linecolor rgb "#B8B8B8" linewidth 5 title "Pareto front"
unset multiplot
