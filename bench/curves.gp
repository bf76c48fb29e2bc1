# curves.gp -- draws the curves for bench/plot.sh. `data` names a file with one block for each curve: the title, then lines with
# bodies and ms per step. `count` is the number of blocks.
set output out
set logscale xy
set xtics ("100" 100, "1,000" 1e3, "10,000" 1e4, "100,000" 1e5, "1 million" 1e6, "10 million" 1e7) rotate by 30 right
set xrange [50:2e7]
set yrange [*:*]
set mxtics 10
set mytics 10
set grid
set xlabel 'bodies' offset 0, 1
# colors that color-blind readers can distinguish (Okabe, Ito, 2008); the shapes of the points differ too
array color[6] = ['#0072b2', '#d55e00', '#009e73', '#e69f00', '#56b4e9', '#000000']
array shape[6] = [7, 5, 9, 6, 4, 8]
set pointsize 0.9
set multiplot layout 1, 2 margins 0.115, 0.985, 0.345, 0.97 spacing 0.135, 0
unset key
set ytics ("10 µs" 1e-2, "0.1 ms" 0.1, "1 ms" 1, "10 ms" 10, "0.1 s" 100, "1 s" 1e3, "10 s" 1e4)
set ylabel 'time of a step' offset 1, 0
plot for [k=0:count - 1] data index k using 1:2 with linespoints lc rgb color[k % 6 + 1] pt shape[k % 6 + 1] title columnheader(1)
set ytics ("0.1 ns" 0.1, "1 ns" 1, "10 ns" 10, "0.1 µs" 100, "1 µs" 1e3, "10 µs" 1e4, "0.1 ms" 1e5)
set yrange [*<100:1e3<*]
set ylabel 'time of a step, a body' offset 1, 0
plot for [k=0:count - 1] data index k using 1:(1e6 * $2 / $1) with linespoints lc rgb color[k % 6 + 1] pt shape[k % 6 + 1] notitle
# the legend is a plot of its own, so that it covers no data
set origin 0, 0
set size 1, 0.12
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.0
set tmargin at screen 0.12
unset border
unset tics
unset xlabel
unset ylabel
unset grid
unset logscale
set xrange [0:1]
set yrange [0:1]
set key center center horizontal Left reverse noenhanced samplen 3 width 1 maxrows 2
plot for [k=0:count - 1] data index k using (NaN):(NaN) with linespoints lc rgb color[k % 6 + 1] pt shape[k % 6 + 1] title columnheader(1)
unset multiplot
