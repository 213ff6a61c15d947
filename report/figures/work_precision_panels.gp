# Error against processor time and against evaluations of the force: what the figures work_precision_bounce and
# work_precision_spring share. They set `unit`.
eval(logarithmic_x); eval(logarithmic_y)
set ylabel sprintf("rms error [%s]", unit) offset 1.5, 0
set yrange [1e-13:10]; set ytics 1e-12, 1e2; set mytics 1; set mxtics 1
racers = schemes . " bogacki_shampine"
set multiplot layout 1, 2 margins 0.13, 0.98, 3.4 / height, 1 - 0.3 / height spacing 0.09, 0
unset key
do for [cost in "seconds evaluations"] {
  if (cost eq "seconds") {
    set xlabel "processor time of a run [s]" offset 0, 0.4
  } else {
    set xlabel "evaluations of the force" offset 0, 0.4
    unset ylabel
  }
  plot csv using (only("case", "clamp", column(cost))):"error" with lines linetype 7 dashtype 2, \
    for [k = 1:words(racers)] csv \
    using (strcol("case") eq "clamp" ? NaN : only("scheme", word(racers, k), column(cost))):"error" \
    with linespoints linetype k
}
eval(shared_key)
set tmargin at screen 1.7 / height; set key maxrows 3 Left reverse samplen 2 spacing 1.0
