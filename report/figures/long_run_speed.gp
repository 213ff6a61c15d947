# The largest speed in still water over very many steps: ./lab study long_run
width = 16; height = 6.5
load "report/figures/style.gp"
eval(logarithmic_y); set ytics 1e-12, 1e2; set mytics 1
unset key
stats csv using (column("step")) nooutput
unit = STATS_max > 1e5 ? 1e6 : 1e3
set xrange [0:STATS_max / unit]
set xlabel (unit == 1e6 ? "steps [million]" : "steps [thousand]")
set ylabel "largest speed [m/s]"
plot csv using (only("run", "still water", column("step") / unit)):"fastest" with lines linetype 1
