// A switch between the versions of this documentation that lie beside each other on a host, HOST/1.0.0/ and so on. Which these are is
// said by HOST/versions.js, which making/versions.py writes; without that file there is no switch. A script and not data, as browsers
// load scripts beside a page that is a file, too.
(function () {
  const root = new URL(DOCUMENTATION_OPTIONS.URL_ROOT, window.location.href);
  const host = new URL("../", root);
  const here = decodeURIComponent(root.href.slice(host.href.length, -1));
  const page = decodeURIComponent(window.location.pathname.slice(root.pathname.length)) || "index.html";

  // Where a version has this page, or else its first one.
  function address(version, pages) {
    return new URL(`${version}/${pages.includes(page) ? page : "index.html"}`, host).href;
  }

  // Called by HOST/versions.js with [version, its pages], newest first.
  window.documentationVersions = function (versions) {
    const brand = document.querySelector(".sidebar-brand");
    if (!brand || versions.length < 2) return;
    const choice = document.createElement("select");
    choice.setAttribute("aria-label", "Version of the documentation");
    choice.className = "versions";
    for (const [version, pages] of versions)
      choice.add(new Option(version, address(version, pages), version === here, version === here));
    choice.addEventListener("change", () => window.location.assign(choice.value));
    brand.after(choice);
  };

  window.addEventListener("DOMContentLoaded", () => {
    const script = document.createElement("script");
    script.src = new URL("versions.js", host).href;
    document.head.append(script);
  });
})();
