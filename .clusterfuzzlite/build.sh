#!/bin/bash -eu
# As OSS-Fuzz builds them.
exec "$SRC/mmverify/fuzz/oss-fuzz/build.sh"
