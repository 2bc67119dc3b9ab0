"""Packs the files of a functional mock-up unit, the same bytes from the same contents: pack.py UNIT.fmu FILE...

Names are relative to where it runs. `cmake -E tar` does the same but writes when files were read and changed.
"""

import sys
import zipfile

with zipfile.ZipFile(sys.argv[1], "w", zipfile.ZIP_DEFLATED) as unit:
    for name in sys.argv[2:]:
        member = zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0))
        member.external_attr = (0o100755 if name.startswith("binaries/") else 0o100644) << 16
        member.create_system = 3  # permissions are Unix's
        with open(name, "rb") as file:
            unit.writestr(member, file.read(), zipfile.ZIP_DEFLATED, 9)
