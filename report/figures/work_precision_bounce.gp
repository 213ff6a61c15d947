# The cost of an error of the bouncing ball: ./lab study work_precision_bounce
width = 16; height = 9.5
load "report/figures/style.gp"
unit = "m"
load "report/figures/work_precision_panels.gp"
plot NaN notitle, for [k = 1:words(racers)] keyentry with linespoints linetype k title spoken(word(racers, k)), \
  keyentry with lines linetype 7 dashtype 2 title "RK4, clamped"
unset multiplot
