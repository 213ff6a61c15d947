# The longest stable step of each integrator, in a lattice of SPH and on a spring: ./lab study stability_map
width = 16; height = 9.5
load "report/figures/style.gp"
greek(letter) = "{/\"Latin Modern Math\" " . letter . "}"
set multiplot layout 1, 3 margins 0.085, 0.985, 3.4 / height, 1 - 0.9 / height spacing 0.085, 0
unset key
set xrange [0:1]; set yrange [0:3.2]; set xtics 0.25; set ytics 1
of(map, scheme, value) = strcol("map") eq map && strcol("scheme") eq scheme ? value : NaN
do for [map in "'cubic spline' 'Wendland C2' 'spring'"] {
  set title (map eq "spring" ? "contact spring" : map eq "cubic spline" ? "lattice, cubic spline" : "lattice, Wendland") \
    offset 0, -0.5
  set xlabel (map eq "spring" ? "damping ratio " . greek("𝜁") : "viscosity " . greek("𝛼")) offset 0, 0.4
  set ylabel (map eq "spring" ? "w dt" : "dt c/h") offset 1, 0
  plot csv using "damping":(of(map, "velocity_verlet", column("limit"))) \
      with filledcurves y1=0 fillcolor rgb green fillstyle transparent solid 0.10 noborder, \
    for [scheme in schemes] csv using "damping":(of(map, scheme, column("theory"))) \
      with lines linecolor rgb grey linewidth 0.8, \
    for [k = 1:words(schemes)] csv using "damping":(of(map, word(schemes, k), column("limit"))) \
      with points linetype k pointsize 0.6, \
    csv using "damping":(strcol("map") eq map && column("reference") > 0 ? column("reference") : NaN) \
      with points pointtype 1 pointsize 0.8 linewidth 1 linecolor rgb "black"
}
eval(shared_key)
set tmargin at screen 1.7 / height; set key maxrows 3 Left reverse samplen 2 spacing 1.0
plot NaN notitle, for [k = 1:words(schemes)] keyentry with points linetype k title spoken(word(schemes, k)), \
  keyentry with lines linecolor rgb grey linewidth 0.8 title "theory", \
  keyentry with points pointtype 1 pointsize 0.8 linewidth 1 linecolor rgb "black" title "reference", \
  keyentry with boxes fillcolor rgb green fillstyle transparent solid 0.10 noborder title "Verlet stable"
unset multiplot
