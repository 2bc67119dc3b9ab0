  return startModule(options).then((module) => {
    const texts = (text) => {
      const size = module.lengthBytesUTF8(text) + 1;
      const at = module._malloc(size);
      module.stringToUTF8(text, at, size);
      return at;
    };
    return {
      /** The answer to a request, both JSON. */
      answer(request) {
        const at = texts(request);
        try {
          return module.UTF8ToString(module._explorer_answer(at));
        } finally {
          module._free(at);
        }
      },
      /** Puts a file where cases and the core itself find it. */
      put(name, bytes) {
        module.FS.writeFile(name, bytes);
      },
    };
  });
}
if (typeof module === "object") module.exports = microslipCore;
