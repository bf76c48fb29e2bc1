# curves.gp -- draws the curves for bench/plot.sh: data has one block a curve (title; bodies, ms a step), count is their number.
set output out
set logscale xy
set format x '10^{%L}'
set xrange [50:2e7]
set grid
set xlabel 'bodies'
set multiplot layout 1, 2
set key left top Left reverse samplen 2
set ylabel 'ms a step'
plot for [k=0:count - 1] data index k using 1:2 with linespoints title columnheader(1)
unset key
set ylabel 'ns a body and step'
plot for [k=0:count - 1] data index k using 1:(1e6 * $2 / $1) with linespoints notitle
unset multiplot
