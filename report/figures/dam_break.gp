# Front against experiments, pressure on the far wall, and where the energy goes: ./lab study dam_break
width = 16; height = 16.5
load "report/figures/style.gp"
stats csv using (strcol("what") eq "ours" ? column("cells") : NaN) nooutput
finest = STATS_max
set multiplot layout 2, 2 margins 0.09, 0.985, 3.9 / height, 1 - 0.9 / height spacing 0.115, 2.6 / height
ours(cells, value) = strcol("what") eq "ours" && column("cells") == cells ? value : NaN
named(what, name, cells, value) = strcol("what") eq what && strcol("name") eq name && column("cells") == cells ? value : NaN
resolutions = "16 32 64 128"
set xlabel "T = t √(2g/a)" offset 0, 0.5
set title offset 0, -0.4
set tics font ",9"

set title "Front"
set ylabel "x/a" offset 1.2, 0
set xrange [0:3.2]; set yrange [1:4.2]; set ytics 1
unset key
experiments = "'Koshizuka & Oka 1996' 'Martin & Moyce 1952 (a = 2.86 cm)' 'Martin & Moyce 1952 (a = 5.72 cm)'"
plot for [k = 1:4] csv using "T":(ours(word(resolutions, k) + 0, column("front"))) with lines linetype 5 - k \
    \
  , csv using "T":(named("peer", "PySPH", 50, column("front"))) with points pointtype 2 pointsize 0.8 linewidth 2 \
    linecolor rgb "black", \
  1 + 2 * x with lines linecolor rgb "#B0B0B0" linewidth 1, \
  for [k = 1:3] csv using "T":(named("experiment", word(experiments, k), 0, column("front"))) with points \
    pointtype 2 * k + 2 pointsize 0.7 linecolor rgb "#505050"

set title "Pressure on the foot of the far wall"
set ylabel "p / ρ_0 g a"
set xrange [2:8]; set yrange [0:*]; set ytics 2
at_rest = 0.5 - 0.1  # water 2 a x a in a tank of 4 a, seen from 0.1 a above its floor
plot at_rest with lines linecolor rgb "#909090" linewidth 1, \
  for [k = 1:4] csv using "T":(ours(word(resolutions, k) + 0, column("wall_pressure"))) with lines linetype 5 - k \
    linewidth 1.3

set title sprintf("Energy, a/dx = %g", finest)
set ylabel "energy / start"
set xrange [0:8]; set yrange [0:1.05]; set ytics 0.2
set label 1 "potential" at 1, 0.93 left textcolor rgb blue font ",9"
set label 2 "kinetic" at 3.4, 0.74 center textcolor rgb orange font ",9"
set label 3 "dissipated" at 5, 0.09 center textcolor rgb green font ",9"
plot csv using "T":(ours(finest, column("potential"))) with lines linetype 1, \
  csv using "T":(ours(finest, column("kinetic"))) with lines linetype 2, \
  csv using "T":(ours(finest, column("dissipated"))) with lines linetype 3, \
  csv using "T":(ours(finest, column("internal"))) with lines linetype 4

unset label
set title "Drift of the total energy"
set ylabel "|drift| / start"
eval(logarithmic_y); set yrange [1e-8:1e-2]; set ytics 10
plot for [k = 1:4] csv using "T":(abs(ours(word(resolutions, k) + 0, column("drift")))) with lines linetype 5 - k \
  linewidth 1.3

eval(shared_key)
set tmargin at screen 2.3 / height
set key maxrows 3 samplen 1.5 noenhanced font ",9"
plot NaN notitle, for [k = 1:4] keyentry with lines linetype 5 - k linewidth 1.6 \
    title "a/dx " . word(resolutions, k), \
  keyentry with lines linecolor rgb "#909090" linewidth 1 title "Ritter; at rest", \
  keyentry with points pointtype 2 pointsize 0.8 linewidth 2 linecolor rgb "black" title "PySPH, a/dx 50", \
  for [k = 1:3] keyentry with points pointtype 2 * k + 2 pointsize 0.7 linecolor rgb "#505050" \
    title word("'Koshizuka & Oka' 'M. & Moyce 2.9 cm' 'M. & Moyce 5.7 cm'", k)
unset multiplot
