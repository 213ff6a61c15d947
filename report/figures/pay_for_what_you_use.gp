# What each law adds to a scene, in time and memory: ./lab study pay_for_what_you_use
width = 16; height = 17
load "report/figures/style.gp"
unset key; unset grid
discs(scene_) = strstrt(scene_, "discs") == 1
itself(law) = law eq "itself"
name(scene_, law, has) = itself(law) ? scene_ . (has eq "as it is" ? "" : ": " . has) : "+ " . law . \
  (column("step") > 1.5 ? sprintf(", dt × %.0f", column("step")) : "")

# Rows are read in the order of the table: each has its line, a scene stands apart from the one before it, and all its
# bars are multiples of the time that the scene itself took.
line = 0; scene = ""; base = 0
start(dummy) = (line = 0, scene = "", 0)
place(name_) = (line = line + (name_ ne scene && scene ne "" ? 1.7 : 1), scene = name_, line)
shown(first) = discs(strcol("scene")) == first
read(first) = (column(0) == 0 ? start(0) : 0, itself(strcol("law")) ? (base = column("before")) : 0, \
  shown(first) ? place(strcol("scene")) : NaN)
# A bar beyond `most` is cut; its number says how long it would be.
most = 0
stats csv using (most = column("before") > most ? column("before") : most) nooutput
most = 1.2 * most
duration(dummy) = itself(strcol("law")) ? base : base * column("ratio")
bar(first) = shown(first) ? (duration(0) > most ? most : duration(0)) : NaN
memory(first) = shown(first) ? column("bytes") : NaN
factor(dummy) = itself(strcol("law")) ? "" : sprintf(column("ratio") < 10 ? " × %.2f" : " × %.1f", column("ratio"))
shade(colour) = itself(strcol("law")) ? 0x8C8C8C : colour

stats csv using (y = read(1)) nooutput
few = line
stats csv using (y = read(0)) nooutput
many = line
half = 0.33
set multiplot
set border 1; unset ytics
row = (height - 3.6) / (few + many + 2)  # cm
top = 1 - 0.3 / height
do for [part = 1:2] {
  first = part == 1
  rows = first ? few : many
  bottom = top - (rows + 0.8) * row / height
  set yrange [rows + 0.7:0.3]
  set tmargin at screen top; set bmargin at screen bottom
  # time
  set lmargin at screen 0.38; set rmargin at screen 0.75
  set xrange [0:*]; set xtics first ? 10 : 100; set offsets graph 0, graph 0.2, 0, 0
  set xlabel first ? "" : "time for one particle and step [ns]" offset 0, 0.6
  plot csv using (0):(y = read(first)):(0):(bar(first)):(y - half):(y + half):(shade(0x0072B2)) \
      with boxxyerror fillstyle solid 0.85 noborder linecolor rgb variable, \
    csv using (y = read(first), shown(first) ? base : NaN):(y - half):(0):(2 * half) with vectors nohead linecolor rgb "#303030" linewidth 1, \
    csv using (y = read(first), bar(first) < base ? base : bar(first)):(y):(factor(0)) with labels left offset 0.3, 0 font ",8", \
    csv using (0):(y = read(first)):(name(strcol("scene"), strcol("law"), strcol("has"))) \
      with labels right offset -0.7, 0 font ",9"
  # memory
  set lmargin at screen 0.79; set rmargin at screen 0.97
  set xtics 100; set offsets graph 0, graph 0.2, 0, 0
  set xlabel first ? "" : "bytes per particle" offset 0, 0.6
  plot csv using (0):(y = read(first)):(0):(memory(first)):(y - half):(y + half):(shade(0xD55E00)) \
      with boxxyerror fillstyle solid 0.85 noborder linecolor rgb variable, \
    csv using (memory(first)):(y = read(first)):(sprintf(" %.0f", column("bytes"))) with labels left offset 0.3, 0 font ",8"
  top = bottom - 1.0 / height
}
unset multiplot
