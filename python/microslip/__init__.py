"""microslip: frictional rolling contact. `python3 -m microslip.plot RESULT.h5` draws the pictures of a result file."""
