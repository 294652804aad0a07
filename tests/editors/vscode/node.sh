#!/usr/bin/env bash
# node.sh SCRIPT ARGUMENTS…: runs it in the extension's folder. Status 77, which ctest shows as skipped, where Node or the extension's
# packages are missing; where CI is set that is a failure.
set -euo pipefail
cd "$(dirname "$0")/../../../vscode-extension"
skip() {
  echo "left out: $*; ./dev test installs it"
  [[ ${CI:-} ]] && exit 1
  exit 77
}
command -v node >/dev/null || skip "node is not installed"
(($(node -p 'process.versions.node.split(".")[0]') >= 20)) || skip "node is older than version 20"
[[ -d node_modules ]] || skip "the packages of vscode-extension/ are not installed"
exec node "$@"
