# Speed after over speed before a contact, by the step: ./lab study stability_map
width = 16; height = 9
load "report/figures/style.gp"
set logscale x; set xtics (0.05, 0.1, 0.2, 0.4, 0.8, 1.6, 3.2)
set xrange [0.025:3.5]; set yrange [0.5:3]
set xlabel "w dt of the contact" offset 0, 0.4
set multiplot layout 1, 2 margins 0.1, 0.985, 2.9 / height, 1 - 0.8 / height spacing 0.07, 0
unset key
of(scheme, value) = strcol("map") eq "contact" && strcol("scheme") eq scheme ? value : NaN
set ylabel "speed after / speed before" offset 1, 0
do for [what in "restitution largest_restitution"] {
  set title (what eq "restitution" ? "mean over the moments of meeting" : "at the worst moment") offset 0, -0.5
  plot 1 with lines linecolor rgb grey linewidth 0.8, \
    csv using "w_dt":(what eq "restitution" ? of("explicit_euler", column("theory")) : NaN) \
      with lines linecolor rgb grey linewidth 0.8, \
    for [k = 1:words(schemes)] csv using "w_dt":(of(word(schemes, k), column(what))) with linespoints linetype k
  unset ylabel
}
eval(shared_key)
set tmargin at screen 1.2 / height; set key maxrows 2 Left reverse samplen 2 spacing 1.0
plot NaN notitle, for [k = 1:words(schemes)] keyentry with linespoints linetype k title spoken(word(schemes, k)), \
  keyentry with lines linecolor rgb grey linewidth 0.8 title "theory"
unset multiplot
