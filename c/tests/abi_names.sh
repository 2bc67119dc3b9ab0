#!/bin/sh
# The library still exports every function of an older header: abi_names.sh NM LIBRARY HEADER
set -eu
"$1" --dynamic --defined-only "$2" | awk '{print $3}' | sed 's/@.*//' | sort >abi_exported_names.txt
sed -n 's/^MICROSLIP_API .*[ *]\(microslip_[a-z0-9_]*\)(.*/\1/p' "$3" | sort >abi_declared_names.txt
[ "$(wc -l <abi_declared_names.txt)" -ge 40 ]
missing=$(comm -23 abi_declared_names.txt abi_exported_names.txt)
[ -z "$missing" ] || { echo "no longer there: $missing"; exit 1; }
