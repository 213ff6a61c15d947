# Explicit against implicit friction: error and cost against the step and the viscosity: ./lab study honey
width = 16; height = 12.5
load "report/figures/style.gp"
load "report/figures/convergence.gp"
when(sweep, flow, step) = strcol("part") eq "run" && strcol("sweep") eq sweep && strcol("flow") eq flow && strcol("step") eq step
kinds = "explicit implicit"
eval(shared_panels(2, 2))
eval(logarithmic_x); eval(logarithmic_y)
unset key
set xlabel "nu dt/h^2" offset 0, 0.6; set xrange [0.03:30]
set ylabel "largest error over U" offset 0.5, 0; set yrange [1e-4:1]
do for [flow in "couette poiseuille"] {
  set title (flow eq "couette" ? "Couette" : "Poiseuille") . " (dotted: steady)" offset 0, -0.5
  plot for [k = 1:2] csv using (when("step", flow, word(kinds, k)) ? column("viscous_number") : NaN):"error" \
         with linespoints linetype k, \
       for [k = 1:2] csv using (when("step", flow, word(kinds, k)) ? column("viscous_number") : NaN):"steady_error" \
         with linespoints linetype k dashtype 3
}
set title "Couette (dotted: Poiseuille)"; set xlabel "processor s per s"; set xrange [*:*]
plot for [k = 1:2] csv using (when("step", "couette", word(kinds, k)) ? column("seconds") : NaN):"error" \
       with linespoints linetype k, \
     for [k = 1:2] csv using (when("step", "poiseuille", word(kinds, k)) ? column("seconds") : NaN):"error" \
       with linespoints linetype k dashtype 3
set title "Couette, dt = auto"; set xlabel "nu [m^2/s]"; set ylabel "processor s per s"; set yrange [*:*]
plot for [k = 1:2] csv using (when("viscosity", "couette", word(kinds, k)) ? column("nu") : NaN):"seconds" \
       with linespoints linetype k
names = "'explicit friction' 'implicit friction'"; load "report/figures/key.gp"
unset multiplot
