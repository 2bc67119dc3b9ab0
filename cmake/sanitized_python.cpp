// Python's interpreter, linked with a sanitizer's run time so that it can load modules that need it.
#include <Python.h>

int main(int argc, char** argv) {
  return Py_BytesMain(argc, argv);
}
