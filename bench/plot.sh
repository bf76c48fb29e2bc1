#!/usr/bin/env bash
# plot.sh -- draws the curves that bench/curves.sh measured, here or on a machine without gnuplot.
#
# usage: bench/plot.sh FOLDER
#   FOLDER  has curves.csv and gets curves.svg and curves.png
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:?is the folder with curves.csv}
command -v gnuplot >/dev/null || { echo "plot.sh: no plots, because there is no gnuplot (Debian: gnuplot-nox)" >&2; exit 0; }
data=$(mktemp)
trap 'rm -f "$data"' EXIT
awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
	{ curve = $column["scene"] ", " $column["device"] }
	curve != last { printf "%s\"%s\"\n", last ? "\n\n" : "", curve; last = curve; }
	{ print $column["bodies"], $column["ms_step"] }' "$folder/curves.csv" >"$data"
count=$(grep -c '^"' "$data")
for terminal in "svg size 1000,420 background 'white'" "pngcairo size 2000,840 fontscale 1.6 linewidth 2"; do
	gnuplot -e "data = '$data'; count = $count; out = '$folder/curves.${terminal:0:3}'; set terminal $terminal" bench/curves.gp ||
		exit 1
done
echo "The curves are $folder/curves.csv, $folder/curves.svg and $folder/curves.png"
