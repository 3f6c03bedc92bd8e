// What screen readers and keyboards want and the theme leaves out: a name for the search, and code that can be scrolled.
document.querySelector('[data-md-component="search"]')?.setAttribute("aria-label", "Search");
for (const code of document.querySelectorAll("pre > code")) {
  if (code.scrollWidth > code.clientWidth) code.tabIndex = 0;
}
