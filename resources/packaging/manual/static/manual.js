// SPDX-License-Identifier: LGPL-2.1-or-later
// Furo of Debian 12 ships its script as a module but loads it as a plain one, so it does not run.
// This switches between the light and the dark theme there. Where Furo's own script runs, the page
// no longer has the class no-js, and this does nothing.
function nextTheme() {
  const isDark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  const order = isDark ? ["auto", "light", "dark"] : ["auto", "dark", "light"];
  const now = order.indexOf(document.body.dataset.theme);
  document.body.dataset.theme = order[(now + 1) % order.length];
  localStorage.setItem("theme", document.body.dataset.theme);
}

window.addEventListener("load", () => {
  const page = document.documentElement;
  if (!page.classList.contains("no-js")) return;
  page.classList.remove("no-js");
  for (const button of document.getElementsByClassName("theme-toggle")) {
    button.addEventListener("click", nextTheme);
  }
});
