#!/usr/bin/env bash
# validate.sh -- writes the table of docs/measurements/validate.md from the CSV of scree validate.
#
# usage: bench/validate.sh [FOLDER]
#   FOLDER  holds before.csv, now.csv and box2d.csv, each optional; default bench/results/validate
# Replaces the rows between the two marks in docs/measurements/validate.md by new rows with the values and their limits. A value beyond its limit
# is bold. Values of Box2D are never bold, because the limits are for Scree.
set -euo pipefail
. "$(dirname "$0")/../tools/usage.sh"
cd "$(dirname "$0")/.."
folder=${1:-bench/results/validate}
document=docs/measurements/validate.md
files=()
for name in before now box2d; do
	[ -e "$folder/$name.csv" ] && files+=("$folder/$name.csv")
done
[ ${#files[@]} -gt 0 ] || { echo "validate.sh: no before.csv, now.csv or box2d.csv in $folder" >&2; exit 1; }

table()
{
	awk -F, '
		function shown(value) { return value !~ /^-?[0-9.e+-]+$/ ? value : value >= 1000 ? sprintf("%.0f", value) : sprintf("%.3g", value) }
		FNR == 1 { column = FILENAME; sub(".*/", "", column); sub("\\.csv$", "", column); next }
		{
			key = $1 FS $2 FS $4
			if (!(key in limit)) order[++count] = key
			unit[key] = $6
			limit[key] = $7
			if ($8 != "shown") {
				if (!(key in judged)) ++of[$1]
				judged[key] = 1
				if ($8 == "pass") ++hold[$1, column]
			}
			if (!($1 in listed)) experiment[++experiments] = $1
			listed[$1] = 1
			seen[column] = 1
			value[key, column] = column != "box2d" && $8 == "fail" ? "**" shown($5) "**" : shown($5)
		}
		function held(name, column) { return column in seen ? hold[name, column] + 0 : "" }
		END {
			print "\n| experiment | rows with a limit | hold with f723e87 | hold now | hold with Box2D |\n| --- | --- | --- | --- | --- |"
			for (k = 1; k <= experiments; ++k) {
				name = experiment[k]
				print "| " name " | " of[name] " | " held(name, "before") " | " held(name, "now") " | " held(name, "box2d") " |"
			}
			for (e = 1; e <= experiments; ++e) {
				name = experiment[e]
				print "\n### " name "\n\n| case | quantity | must be | f723e87 | now | Box2D |\n| --- | --- | --- | --- | --- | --- |"
				for (k = 1; k <= count; ++k) {
					key = order[k]
					split(key, part, FS)
					if (part[1] == name)
						print "| " part[2] " | " part[3] (unit[key] ? ", " unit[key] : "") " | " limit[key] " | " \
							value[key, "before"] " | " value[key, "now"] " | " value[key, "box2d"] " |"
				}
			}
		}' "${files[@]}"
}

rows=$(table)
ROWS=$rows awk '
	/^<!-- rows -->$/ { print; print ENVIRON["ROWS"]; print ""; skip = 1 }
	/^<!-- end of rows -->$/ { skip = 0 }
	!skip' "$document" >"$document.new"
mv "$document.new" "$document"
