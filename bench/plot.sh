#!/usr/bin/env bash
# plot.sh -- draws the curves that bench/curves.sh measured, on this machine or on another one.
#
# usage: bench/plot.sh FOLDER
#   FOLDER  contains curves.csv, and gets curves.svg and curves.png
set -euo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.."
folder=${1:?is the folder with curves.csv}
command -v gnuplot >/dev/null || { echo "plot.sh: draws no curves, because gnuplot was not found (Debian: gnuplot-nox)" >&2; exit 0; }
data=$(mktemp)
trap 'rm -f "$data"' EXIT
# the short name of the processor, for example "Intel Xeon" for the line "processor: Intel(R) Xeon(R) Processor, 16 cores"
processor=CPU
[ -e "$folder/machine.txt" ] && processor=$(sed -n 's/^processor: //p' "$folder/machine.txt" | sed 's/(R)\|(TM)\| Processor\| CPU//g; s/ *[,(@].*//')
awk -F, -v processor="${processor:-CPU}" 'NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
	{
		device = $column["device"]
		gsub(/_/, " ", device)
		if (!sub(/^opencl:/, "", device))
			device = processor ", " $column["threads"] ($column["threads"] == 1 ? " thread" : " threads")
		else
			device = device ", OpenCL"
		curve = $column["scene"] ", " device
	}
	curve != last { printf "%s\"%s\"\n", last ? "\n\n" : "", curve; last = curve; }
	{ print $column["bodies"], $column["ms_step"] }' "$folder/curves.csv" >"$data"
count=$(grep -c '^"' "$data")
for terminal in "svg size 1100,480 font 'Helvetica,19' linewidth 1.6 background 'white'" "pngcairo size 2200,960 font 'Helvetica,19' fontscale 1.5 linewidth 2.5"; do
	gnuplot -e "data = '$data'; count = $count; out = '$folder/curves.${terminal:0:3}'; set terminal $terminal" bench/curves.gp ||
		exit 1
done
echo "The curves are $folder/curves.csv, $folder/curves.svg and $folder/curves.png"
