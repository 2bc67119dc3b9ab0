#!/bin/sh
# In a virtual environment that has the wheel: the command, the module and the pictures, with none but the carried
# libraries: wheel.sh ENVIRONMENT
set -eux
environment=$(cd "$1" && pwd)
work=$(mktemp -d)
cd "$work"
unset PYTHONPATH MICROSLIP_PYTHON
package=$("$environment/bin/python" -c "import microslip, os; print(os.path.dirname(microslip.__file__))")
case $package in "$environment"/*) ;; *) exit 1 ;; esac
if ldd "$package"/_core*.so "$package"/bin/microslip* | grep -E "hdf5|csv|gomp|sz|fmt" | grep -v "$package/"; then exit 1; fi
"$environment/bin/microslip" --version
"$environment/bin/python" -m microslip init wheel.toml
"$environment/bin/microslip" solve wheel.toml -o results | grep -q "status  *ok  *ok"
test -f results/tractions.png
"$environment/bin/microslip" validate carter --no-pictures
"$environment/bin/python" -c "import h5py, microslip
print(microslip.__version__, microslip.CreepForceTable(poisson_ratio=0.28))
case = microslip.read_case('wheel.toml')
here = microslip.Solver(case.method).solve(case.problem).forces.fx
there = h5py.File('results/result.h5')['exact/fx'][()]
print(here, there)
assert abs(here - there) < 1e-9 * abs(there)"
echo "wheel: all is as it should be"
