# The error of the energy over very many steps: ./lab study long_run
width = 16; height = 12
load "report/figures/style.gp"
set multiplot layout 2, 2 margins 0.1, 0.98, 2.0 / height, 1 - 0.8 / height spacing 0.13, 2.7 / height
unset key
stats csv using (column("step")) nooutput
last = STATS_max
unit = last > 1e5 ? 1e6 : 1e3
set xrange [0:last / unit]
set style fill transparent solid 0.25 noborder
do for [run in "'springs' 'bouncing stack' 'lattice' 'still water'"] {
  set title run offset 0, -0.5
  set xlabel (unit == 1e6 ? "steps [million]" : "steps [thousand]") offset 0, 0.4
  if (run eq "bouncing stack") {
    set ylabel "energy error" offset 0.3, 0
    eval(logarithmic_y); set ytics 1e-8, 1e2; set mytics 1
    set key bottom right
    plot csv using (only("run", run, column("step") / unit)):(abs(column("energy_error"))) \
        with lines linetype 2 linewidth 1 title "automatic step", \
      csv using (only("run", run . " at half the step", column("step") / unit)):(abs(column("energy_error"))) \
        with lines linetype 1 linewidth 1 title "half of it"
    unset logscale y; set format y "%h"; unset key
  } else {
    stats csv using (only("run", run, column("most"))) nooutput
    high = STATS_max
    stats csv using (only("run", run, column("least"))) nooutput
    low = STATS_min
    power = floor(log10(high > -low ? high : -low))
    span = (high - low) / 10 ** power
    step = span > 8 ? 4 : span > 4 ? 2 : span > 2 ? 1 : 0.5
    set ytics step
    set ylabel sprintf("energy error [10^{%d}]", power) offset 0.3, 0
    plot 0 with lines linecolor rgb grey linewidth 0.8, \
      csv using (only("run", run, column("step") / unit)):(column("least") / 10 ** power): \
        (column("most") / 10 ** power) with filledcurves linetype 1, \
      csv using (only("run", run, column("step") / unit)):(column("energy_error") / 10 ** power) \
        with lines linetype 1 linewidth 1
  }
}
unset multiplot
