#!/bin/sh
# Asks the native core and the one for browsers the same: same_answers.sh ANSWERS CORE.js EXAMPLES. 77: not built.
command -v node >/dev/null || { echo "skipped: node is missing"; exit 77; }
[ -f "$2" ] || { echo "skipped: $2 is missing, which tools/explorer makes"; exit 77; }
exec node "$(dirname "$0")/same_answers.js" "$@"
