// SPDX-License-Identifier: BSD-3-Clause
// Light, dark, or as the system says: a button goes round, and the choice is remembered.
"use strict";

const kChoices = ["system", "light", "dark"];

function chosenColours() {
  try {
    const kept = localStorage.getItem("relievo-colours");
    return kChoices.includes(kept) ? kept : "system";
  } catch (refused) {
    return "system";  // Some browsers keep nothing for pages that are files.
  }
}

function showColours(choice) {
  document.documentElement.dataset.colours = choice;
  const button = document.getElementById("colours");
  if (!button) return;
  button.textContent = "Colours: " + choice;
  button.hidden = false;
}

// Before anything is drawn; the button comes with the page.
showColours(chosenColours());
document.addEventListener("DOMContentLoaded", () => {
  showColours(chosenColours());
  document.getElementById("colours").addEventListener("click", () => {
    const now = document.documentElement.dataset.colours;
    const next = kChoices[(kChoices.indexOf(now) + 1) % kChoices.length];
    try {
      localStorage.setItem("relievo-colours", next);
    } catch (refused) {
      // Then it holds for this page.
    }
    showColours(next);
  });
});
