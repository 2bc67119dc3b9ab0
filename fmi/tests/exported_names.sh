#!/bin/sh
# The binary exports the functions of the standard and no other name: exported_names.sh NM BINARY HEADER COUNT
set -eu
version=$(basename "$3" .h)
names=$(mktemp -d)
trap 'rm -rf "$names"' EXIT
"$1" --dynamic --defined-only "$2" | awk '{print $3}' | sed 's/@.*//' | sort >"$names/exported"
# Those of FMI 3.0 for types of values come from a macro.
sed '/^#define/d' "$3" | tr '\n' ' ' | sed 's/;/\n/g; s/FMI3_VALUES(\([A-Za-z0-9]*\))/\nFMI3_API fmi3Get\1(\nFMI3_API fmi3Set\1(\n/g' |
  sed -n "s/^.*FMI[23]_API .*[ *]*\($version[A-Za-z0-9]*\)(.*/\1/p" | sort >"$names/declared"
[ "$(wc -l <"$names/declared")" -eq "$4" ]
diff "$names/declared" "$names/exported"
