# What all figures share. Called with `csv` (the table of a study), `figure` (the file to draw) and, by a figure that
# needs more room, `width` and `height` [cm]; the ending of `figure` says what is drawn: pdf, svg or png.
if (!exists("width")) width = 16
if (!exists("height")) height = 7.5
set datafile separator ","
set datafile columnheaders
set datafile missing "nan"
set encoding utf8

# Colours that stay apart for the colour-blind, and in this order on a grey printer (Okabe & Ito 2008).
blue = "#0072B2"; orange = "#D55E00"; green = "#009E73"; violet = "#CC79A7"; sky = "#56B4E9"; yellow = "#E69F00"; grey = "#7F7F7F"
set linetype 1 linecolor rgb blue   linewidth 1.6 pointtype 7  pointsize 0.5
set linetype 2 linecolor rgb orange linewidth 1.6 pointtype 5  pointsize 0.5
set linetype 3 linecolor rgb green  linewidth 1.6 pointtype 9  pointsize 0.6
set linetype 4 linecolor rgb violet linewidth 1.6 pointtype 13 pointsize 0.6
set linetype 5 linecolor rgb sky    linewidth 1.6 pointtype 11 pointsize 0.6
set linetype 6 linecolor rgb yellow linewidth 1.6 pointtype 4  pointsize 0.6
set linetype 7 linecolor rgb grey   linewidth 1.6 pointtype 6  pointsize 0.6
set linetype cycle 7

set border 3 linecolor rgb "#404040" linewidth 0.8
set tics nomirror out scale 0.6
set grid linecolor rgb "#E4E4E4" linewidth 0.6 linetype 1 dashtype 1
set key samplen 2 spacing 1.15
set format x "%h"; set format y "%h"

# Logarithmic axes with powers of ten.
logarithmic_x = "set logscale x; set format x '10^{%L}'"
logarithmic_y = "set logscale y; set format y '10^{%L}'"

# Rows of which the column `name` has the word `wanted`; others count as missing.
only(name, wanted, value) = strcol(name) eq wanted ? value : NaN
# explicit_euler as it is read.
spoken(name) = name eq "explicit_euler" ? "explicit Euler" : name eq "symplectic_euler" ? "symplectic Euler" : \
  name eq "velocity_verlet" ? "Verlet" : name eq "rk2" ? "RK2" : name eq "rk4" ? "RK4" : \
  name eq "bogacki_shampine" ? "Bogacki–Shampine" : name
schemes = "explicit_euler symplectic_euler velocity_verlet rk2 rk4"

# Panels with titles, columns x rows, and below them room for a key that all share (key.gp).
panels(columns, rows) = sprintf("set multiplot layout %d, %d margins 0.09, 0.98, %g, %g spacing 0.11, %g", \
  rows, columns, 2.5 / height, 1 - 0.8 / height, 2.6 / height)
# The same where a key has other things than line types 1, 2, ...: then a last plot of NaN and keyentry, in several lines
# if it is long (set key maxrows).
shared_key = "set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0; " . \
  sprintf("set tmargin at screen %g; ", 0.8 / height) . \
  "unset border; unset tics; unset xlabel; unset ylabel; unset title; unset grid; unset logscale; " . \
  "set xrange [0:1]; set yrange [0:1]; set key center center horizontal maxrows 1"
# The names of all schemes, for a key.
scheme_names = "'explicit Euler' 'symplectic Euler' Verlet RK2 RK4"

ending = figure[strlen(figure) - 2 : ]
if (ending eq "pdf") {
  set terminal pdfcairo size width cm, height cm font "Latin Modern Roman,10" fontscale 0.9
} else { if (ending eq "svg") {
  set terminal svg size width * 50, height * 50 font "DejaVu Sans,15" background rgb "white"
} else {
  set terminal pngcairo size width * 75, height * 75 font "DejaVu Sans,17" background rgb "white"
} }
set output figure
