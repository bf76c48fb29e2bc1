#!/usr/bin/env bash
# bench.sh -- measures scenes of fixed sizes on the CPU, and on the GPU if the machine has one, then draws the curves.
#
# usage: bench/bench.sh [NAME]
#   NAME  folder in bench/results for bench.csv, machine.txt and the curves; default local
# CURVES=no leaves out the curves; SCREE is the path of the command line (build/scree). Hashes must be equal to those in
# bench/known.csv. After a change that must change hashes, KNOWN=write writes that file from the rows of the CPU. Exit 1 when a row
# is invalid.
set -uo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.." || exit 1
folder=bench/results/${1:-local}
scree=${SCREE:-build/scree}
export SCREE=$scree
mkdir -p "$folder"
known=()
[ -e bench/known.csv ] && [ "${KNOWN:-}" != write ] && known=(--known bench/known.csv)

# the first OpenCL device whose driver is not PoCL, because devices of PoCL are CPUs
devices=(cpu)
gpu=$("$scree" devices | awk '/^opencl:/ { name = $0 } / driver / && name { if (!/Portable Computing Language/) { print name; exit } name = "" }')
[ -z "$gpu" ] || devices+=("$gpu")
{
	echo "commit: ${COMMIT:-$(git describe --always --dirty 2>/dev/null || echo unknown)}"
	echo "processor: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores"
	"$scree" devices
} >"$folder/machine.txt"

# Prints the rows of all scenes on all devices, with a heading from each command.
measure()
{
	local failed=0 device
	for device in "${devices[@]}"; do
		"$scree" bench pyramid pyramids pile tumbler smash washer storm churn --steps 300 --device "$device" "${known[@]}" || failed=1
		"$scree" bench million --steps 60 --repeats 1 --device "$device" "${known[@]}" || failed=1
	done
	return $failed
}
failed=0
measure | awk 'NR == 1 { heading = $0 } NR == 1 || $0 != heading { print; fflush() }' | tee "$folder/bench.csv" || failed=1
if [ "${CURVES:-yes}" = yes ]; then
	bench/curves.sh "$folder" "${devices[@]}" || failed=1
fi
if [ "${KNOWN:-}" = write ]; then
	cat "$folder/bench.csv" "$folder/curves.csv" | awk -F, '
		!column["hash"] { for (k = 1; k <= NF; ++k) column[$k] = k; print "scene,settings,steps,hash" }
		$column["device"] == "cpu" && $column["valid"] {
			print $column["scene"] "," $column["settings"] "," $column["steps"] "," $column["hash"] }' >bench/known.csv
fi
echo "The results are in $folder"
exit $failed
