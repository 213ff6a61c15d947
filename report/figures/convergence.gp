# What the figures of convergence share, after style.gp: rows that are left out do not break a line, resolution runs along
# a logarithmic axis, small keys stand in the panels.
set datafile missing NaN
grey_line = "#A0A0A0"
resolution_axis(name, from, to) = "set logscale xy; set format y '10^{%L}'; set ytics autofreq; " . \
  sprintf("set xlabel '%s'; set xrange [%g:%g]", name, from, to)
small_key = "samplen 1.2 spacing 0.95 font ',8' Left reverse"
# Panels with room for labels of logarithmic axes, and below them for a shared key (key.gp), or with keys of their own.
room(columns, rows, below) = sprintf("set multiplot layout %d, %d margins 0.115, 0.98, %g, %g spacing 0.145, %g", \
  rows, columns, below / height, 1 - 0.8 / height, 2.5 / height)
shared_panels(columns, rows) = room(columns, rows, 2.5)
keyed_panels(columns, rows) = room(columns, rows, 1.7)
