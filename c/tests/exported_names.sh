#!/bin/sh
# The library exports the functions that the header declares and no other name: exported_names.sh NM LIBRARY HEADER
set -eu
"$1" --dynamic --defined-only "$2" | awk '{print $3}' | sed 's/@.*//' | sort >exported_names.txt
sed -n 's/^MICROSLIP_API .*[ *]\(microslip_[a-z0-9_]*\)(.*/\1/p' "$3" | sort >declared_names.txt
[ "$(wc -l <declared_names.txt)" -ge 19 ]
diff declared_names.txt exported_names.txt
