# What an update of a particle costs against their number, and what threads gain: ./lab study scaling
width = 16; height = 7.5
load "report/figures/style.gp"
set datafile missing NaN  # the rows of the curves alternate
eval(logarithmic_x)
set xlabel "particles of liquid" offset 0, 0.6
set xrange [1.4e3:1.5e6]
# The numbers of threads that the table has.
counts = ""
collect(word_) = (strstrt(" " . counts . " ", " " . word_ . " ") == 0 ? (counts = counts . (strlen(counts) ? " " : "") . word_, 0) : 0)
stats csv using (collect(strcol("threads"))) nooutput
last = words(counts)
most = real(word(counts, last))
eval(panels(2, 1))
unset key
set ylabel "time for one update [ns]" offset 0.8, 0
stats csv using (only("threads", "1", column("update"))) nooutput
set yrange [0:1.3 * STATS_max]  # many threads on a busy machine may take any time: the other panel tells
plot for [k = 1:last] csv using "particles":(only("threads", word(counts, k), column("update"))) with linespoints linetype k
set ylabel "speed-up" offset 1, 0
set yrange [0:most * 1.15]
set arrow 1 from graph 0, first most to graph 1, first most nohead linecolor rgb "#B0B0B0" linewidth 1
plot for [k = last > 1 ? 2 : 1:last] csv using "particles":(only("threads", word(counts, k), column("speed_up"))) with linespoints linetype k
unset arrow
names = ""
do for [k = 1:last] { names = names . "'" . word(counts, k) . (word(counts, k) eq "1" ? " thread' " : " threads' ") }
load "report/figures/key.gp"
unset multiplot
