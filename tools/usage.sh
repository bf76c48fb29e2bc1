# SPDX-License-Identifier: MIT
# usage.sh -- is sourced by scripts: for --help, prints the comment at the head of the script and exits. Refuses all other options,
# and all arguments if the line "usage:" of that comment names none.
for argument in "$@"; do
	case $argument in
	-h | --help)
		sed -n '/^# [a-z_]*\.sh -- /,/^[^#]/s/^# \{0,1\}//p' "$0"
		exit 0
		;;
	-*)
		echo "${0##*/}: unknown option $argument; --help lists the arguments" >&2
		exit 2
		;;
	esac
done
if [ $# -gt 0 ] && [ -z "$(sed -n 's/^# usage: [^ ]*//p' "$0")" ]; then
	echo "${0##*/}: unexpected argument $1; the script takes none" >&2
	exit 2
fi
