#!/bin/sh
# evaluate.sh PARAMETERS RESULTS - one evaluation for Dakota, which adds both names to the call.
exec squat run light-defect --mesh draft --parameters "$1" --results "$2"
