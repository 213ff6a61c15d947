# The key that the panels of a multiplot share, as its last plot: `names` in quotes, of line types 1, 2, ...
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0; set tmargin at screen 0.9 / height
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset grid; unset logscale; unset key
set xrange [0:1]; set yrange [0:1]
count = words(names); all = 0
do for [k = 1:count] { all = all + strlen(word(names, k)) + 6 }
at = 0.5 - 0.0060 * all
do for [k = 1:count] {
  set label 100 + k word(names, k) at graph at, graph 0.5 left offset 1.2, 0 point linetype k pointsize 0.8
  at = at + 0.012 * (strlen(word(names, k)) + 6)
}
plot NaN notitle
do for [k = 1:count] { unset label 100 + k }
