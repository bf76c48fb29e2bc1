#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# test_sleep_bench.sh -- checks scree_sleep on small worlds: rows, contacts, sleeping bodies, equal hashes on all devices, and
# messages.
set -uo pipefail
scree=${SCREE_BINARY:?is the path of the command line}
. "${SCREE_SOURCE:?}/tests/cli_support.sh"
begin "${scree%/*}/scree_sleep"

# 20 sleeping pyramids of 55 boxes, 55 awake boxes or 11 balls, and a pyramid of 36 boxes that wakes
small=(--sleepers 1100 --rows 8 --steps 5 --repeats 1 --csv)

# help and bad command lines
expect 0 'usage: scree_sleep' --help
names=$(sed -nE '/^Cases/,$s/^  ([a-z-]+) .*/\1/p' out)
[ "$(wc -w <<<"$names")" = 12 ] || fail "--help: other cases than" "$names"
refuse 2 '--case dance: must be a case' --case dance
refuse 2 '--rows 0: must be a whole number from 1 to 200' --rows 0
refuse 2 '--steps 5x: must be' --steps 5x
refuse 2 'unexpected argument part' part
refuse 2 'frobnicate' --frobnicate
refuse 1 'moon' --device moon --case all

# all cases: value NAME CASE prints the value of a column, of the first world of a case
value() { awk -F, -v name="$1" -v case="$2" 'NR == 1 { for (k = 1; k <= NF; ++k) if ($k == name) at = k } $1 == case { print $at; exit }' rows.csv; }
expect_value()
{
	[ "$(value "$2" "$1")" = "$3" ] || fail "$1: $2 is $(value "$2" "$1") instead of $3"
}
words=()
for name in $names; do
	words+=(--case "$name")
done
expect 0 '' --device cpu --threads 1 "${small[@]}" "${words[@]}"
cp out rows.csv
head -n 1 rows.csv | grep -qx 'case,world,device,.*,asleep,contacts,touching,.*,penetration,hash,valid' || fail "another heading"
awk -F, 'NR == 1 { count = NF } NF != count || (NR > 1 && $NF != 1) { bad = 1 } END { exit bad }' rows.csv ||
	fail "a row that is not valid, or has not a column for each name"
[ "$(sed 1d rows.csv | cut -d, -f 1 | uniq)" = "$names" ] || fail "not a row for each case"
[ "$(grep -cE '^(part|balls|awake),' rows.csv)" = 6 ] || fail "not two rows for each case with two worlds"

# A pyramid of 10 rows has 10 contacts with the shelf, 45 between neighbors in a row, and 90 between rows.
expect_value all asleep 1100
expect_value all contacts $((20 * 145))
expect_value all touching $((20 * 145))
expect_value part asleep 1100
expect_value part contacts $((21 * 145))
expect_value balls bodies $((1 + 1100 + 11))
expect_value ball bodies $((1 + 1100 + 1))
expect_value awake asleep 0
expect_value spawn bodies $((1 + 1100 + 32))
expect_value ray found 45
expect_value sensor found $((44 * 55))
for name in wake-created wake-hit wake-body wake-world; do
	expect_value $name asleep 0
	expect_value $name bodies 37
	[ "$(value ms_first $name | wc -w)" = 8 ] || fail "$name: not eight first steps"
done
# an island wakes as a whole, by whichever call
expect_value wake-body hash "$(value hash wake-world)"
for name in $names; do
	case $name in
	part | balls | awake | wake-*) [ "$(value ratio "$name")" ] || fail "$name: no ratio" ;;
	*) expect_value "$name" ratio '' ;;
	esac
done

# the state at the end is the same with other threads and lanes, and on an OpenCL device if there is one
facts() { awk -F, 'NR == 1 { for (k = 1; k <= NF; ++k) keep[k] = $k !~ /^(device|threads|lanes|ratio|bytes_a_body|ms_.*)$/ } { for (k = 1; k <= NF; ++k) if (keep[k]) printf "%s,", $k; print "" }'; }
others=("cpu --threads 2 --lanes 1")
"$scree" devices | grep -q '^opencl:' && others+=("opencl")
for other in "${others[@]}"; do
	read -ra place <<<"$other"
	expect 0 '' --device "${place[@]}" "${small[@]}" "${words[@]}"
	diff <(facts <rows.csv) <(facts <out) || fail "--device $other: another state than on one thread"
done

# without --csv: names and values
expect 0 "hash          $(value hash all)" --device cpu "${small[@]:0:8}" --case all

end
