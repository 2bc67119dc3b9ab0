"""A page in a temporary folder, for the tests."""

import tempfile
import unittest
from pathlib import Path

PAGE = """A page.

```python
print(1 + 1)
```

<!-- output -->
```text
2
```

<!-- not run: a drawing -->
```text
o--o
```
"""


class PageTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def page(self, text):
        path = self.folder / "page.md"
        path.write_text(text)
        return path
