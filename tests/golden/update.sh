#!/bin/sh
# Draws the golden pictures again, from the programs of a build folder. Look at each before committing it.
# usage: tests/golden/update.sh BUILD_FOLDER
set -eu
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/bin/docent-content" compile "$here/../../config/museum" -o "$work/museum.db" --quiet
cd "$work"
"$build/bin/docent" --display headless --size 480x270 --content museum.db --config none.toml --visit "$here/golden.visit"
mv welcome.png choosing.png walking.png arrived.png "$here/"
