#!/usr/bin/env bash
# Debian's Chromium for the browser tests: installed where it is missing and may be; else those tests say they skip.
set -u
for name in chromium chromium-browser google-chrome; do
    command -v "$name" >/dev/null 2>&1 && exit 0
done
if command -v apt-get >/dev/null 2>&1 && [ "$(id -u)" = 0 ]; then
    echo "installing Chromium for the browser tests"
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq chromium; } >/dev/null 2>&1 && exit 0
fi
echo "no Chromium here and it may not be installed: the browser tests will be skipped" >&2
exit 0
