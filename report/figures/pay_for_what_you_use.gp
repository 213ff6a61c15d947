# What each law adds to a scene, in time and memory: ./lab study pay_for_what_you_use
width = 16; height = 17
load "report/figures/style.gp"
unset key; unset grid
discs(scene_) = strstrt(scene_, "discs") == 1
row = 0; scene = ""; total = 0; few = 0
# The rows in their order, one more before each scene but the first.
place(name) = (row = row + (name ne scene && scene ne "" ? 1.7 : 1), scene = name, row)
restart(dummy) = (row = 0, scene = "", 0)
stats csv using (discs(strcol("scene")) ? place(strcol("scene")) : NaN) nooutput
few = row
dummy = restart(0)
stats csv using (discs(strcol("scene")) ? NaN : place(strcol("scene"))) nooutput
many = row
itself(law) = law eq "itself"
shown(first) = discs(strcol("scene")) == first
at(first) = shown(first) ? place(strcol("scene")) : NaN
here(first, name_) = shown(first) ? column(name_) : NaN
name(scene_, law, has) = itself(law) ? scene_ . (has eq "as it is" ? "" : ": " . has) : "+ " . law
half = 0.33

set multiplot
set border 1; unset ytics; set xtics 100
unit = (height - 3.6) / (few + many + 2)  # cm per row
top = 1 - 0.3 / height
do for [part = 1:2] {
  first = part == 1
  rows = first ? few : many
  bottom = top - (rows + 0.8) * unit / height
  set yrange [rows + 0.7:0.3]
  set tmargin at screen top; set bmargin at screen bottom
  # time
  set lmargin at screen 0.40; set rmargin at screen 0.74
  set xrange [0:*]; set xtics first ? 20 : 100; set offsets graph 0, graph 0.16, 0, 0
  set xlabel first ? "" : "time for one particle and step [ns]" offset 0, 0.6
  dummy = restart(0)
  plot csv using (0):(y = at(first)):(0):(here(first, "time")):(y - half):(y + half):(itself(strcol("law")) ? 0x7F7F7F : 0x0072B2) \
      with boxxyerror fillstyle solid 0.85 noborder linecolor rgb variable, \
    csv using (restart_once = column(0) == 0 ? restart(0) : 0, y = at(first), here(first, "before")):(y - half):(0):(2 * half) \
      with vectors nohead linecolor rgb "#404040" linewidth 1, \
    csv using (shown(first) && column("time") < column("before") ? column("before") : here(first, "time")):(restart_once = column(0) == 0 ? restart(0) : 0, at(first)):\
      (itself(strcol("law")) ? "" : sprintf(column("ratio") < 10 ? " × %.2f" : " × %.1f", column("ratio"))) with labels left offset 0.3, 0 font ",8", \
    csv using (0):(restart_once = column(0) == 0 ? restart(0) : 0, at(first)):(name(strcol("scene"), strcol("law"), strcol("has"))) \
      with labels right offset -0.7, 0 font ",9"
  # memory
  set lmargin at screen 0.79; set rmargin at screen 0.97
  set offsets graph 0, graph 0.2, 0, 0; set xtics 100
  set xlabel first ? "" : "bytes per particle" offset 0, 0.6
  dummy = restart(0)
  plot csv using (0):(y = at(first)):(0):(here(first, "bytes")):(y - half):(y + half):(itself(strcol("law")) ? 0x7F7F7F : 0xD55E00) \
      with boxxyerror fillstyle solid 0.85 noborder linecolor rgb variable, \
    csv using (here(first, "bytes")):(restart_once = column(0) == 0 ? restart(0) : 0, at(first)):(sprintf(" %.0f", column("bytes"))) \
      with labels left offset 0.3, 0 font ",8"
  top = bottom - 1.0 / height
}
unset multiplot
