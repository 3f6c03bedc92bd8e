#!/usr/bin/env bash
# What the tests take from Debian: Chromium, the W3C's definition of SVG, a broker of MQTT. Installed where it is missing and may be;
# else the tests that need it say they are skipped.
set -u
wanted=()
found=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
[ -n "$found" ] || wanted+=(chromium)
[ -d /usr/share/xml/w3c-sgml-lib ] || wanted+=(w3c-sgml-lib)
[ -x "$(PATH=$PATH:/usr/sbin command -v mosquitto)" ] || wanted+=(mosquitto)
[ ${#wanted[@]} -eq 0 ] && exit 0
if command -v apt-get >/dev/null 2>&1 && [ "$(id -u)" = 0 ]; then
    echo "installing for the tests: ${wanted[*]}"
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "${wanted[@]}"; } >/dev/null 2>&1 && exit 0
fi
echo "not here and may not be installed: ${wanted[*]}; the tests that need it will be skipped" >&2
exit 0
