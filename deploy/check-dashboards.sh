#!/usr/bin/env bash
# Checks the expressions of the dashboard and of the alert rules with promtool, and when the alerts
# fire. ctest runs the same as deploy_monitoring.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

"$here/install-deps.sh" packages-test.txt
exec /usr/bin/python3 "$here/../tests/deploy/monitoring_test.py"
