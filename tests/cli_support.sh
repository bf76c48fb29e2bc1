# SPDX-License-Identifier: MIT
# cli_support.sh -- functions for scripts that test a command line.

# begin PROGRAM: changes to a scratch folder; skips the test if the program was not built
begin()
{
	program=$1
	[ -x "$program" ] || { echo "no command line was built"; exit 77; }
	scratch=$(mktemp -d "${SCREE_BUILD:?}/cli.XXXXXX")
	trap 'rm -rf "$scratch"' EXIT
	cd "$scratch" || exit 1
	failures=0
}

fail()
{
	echo "FAILED: $*"
	sed 's/^/    | /' out err
	failures=$((failures + 1))
}

# expect CODE TEXT words...: runs the program with the words; it must exit with CODE, and print TEXT
expect()
{
	local code=$1 text=$2 got
	shift 2
	"$program" "$@" >out 2>err </dev/null
	got=$?
	[ "$got" = "$code" ] || fail "${program##*/} $*: exit code $got instead of $code"
	grep -qF -- "$text" out err || fail "${program##*/} $*: does not say \"$text\""
}

# refuse CODE TEXT words...: like expect, but the program must print nothing to standard output
refuse()
{
	expect "$@"
	[ -s out ] && fail "${program##*/} ${*:3}: prints results in spite of the error"
}

# prints the number of failures; fails if there are any
end()
{
	echo "$failures failures"
	[ "$failures" = 0 ]
}
