#!/bin/sh
# Holds the JSON schema of case files against a validator.
#   schema.sh WASHTUB
set -eu
WASHTUB_PROGRAM=$1 npm --prefix "$(dirname "$0")/../../viewer" run --silent schema
