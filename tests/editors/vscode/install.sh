#!/usr/bin/env bash
# VS Code as a web server, in the build of the npm package code-server, into a cache folder. Nothing is compiled. Prints nothing if it is there.
set -euo pipefail
version=4.100.3 # the last for Node 20
# npm's sum of the package.
sum=q/Fh2DOxCRNhC/WiG/6sAhSKnj7ZACTVBaeeZ+rWjol//0FCbl/qg1ln5ecZ99jYcfqMxZZAyWcN+YBIo0DgpA==
cache="${XDG_CACHE_HOME:-$HOME/.cache}/texbrdf/vscode-$version"
[[ -e $cache/complete ]] && exit

echo "installing VS Code for the tests: $cache"
rm -rf "$cache"
mkdir -p "$cache"
cd "$cache"
npm pack --silent "code-server@$version" >/dev/null
[[ $(openssl dgst -sha512 -binary "code-server-$version.tgz" | base64 -w0) == "$sum" ]]
tar xzf "code-server-$version.tgz"
rm "code-server-$version.tgz"
cd package/lib/vscode
npm install --ignore-scripts --omit=dev --no-audit --no-fund --loglevel=error # its npm-shrinkwrap.json pins everything
ln -sfn node_modules node_modules.asar
touch "$cache/complete"
