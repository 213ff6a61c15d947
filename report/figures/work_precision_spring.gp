# The cost of an error of two discs in contact: ./lab study work_precision_spring
width = 16; height = 9.5
load "report/figures/style.gp"
unit = "px"
load "report/figures/work_precision_panels.gp"
plot NaN notitle, for [k = 1:words(racers)] keyentry with linespoints linetype k title spoken(word(racers, k))
unset multiplot
