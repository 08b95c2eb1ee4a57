// Compares two pictures of the report: one over the other, with a wipe between them. Without this script all pictures are in the gallery.
(function () {
  "use strict";
  const figures = Array.from(document.querySelectorAll("figure.ray"));
  const compare = document.getElementById("compare");
  if (!compare || figures.length < 2) return;
  const part = (name) => compare.querySelector("[data-part=" + name + "]");
  const stage = part("stage"), wipe = part("wipe");
  const sides = { a: null, b: null };

  // A side shows a figure: picture, legend, name, and the choice in its list.
  function show(side, figure) {
    sides[side] = figure;
    const picture = figure.querySelector("img.picture"), legend = figure.querySelector("img.legend");
    part("picture-" + side).src = picture.src;
    part("picture-" + side).alt = picture.alt;
    part("legend-" + side).src = legend.src;
    part("legend-" + side).alt = legend.alt;
    part("name-" + side).textContent = side.toUpperCase() + "  " + figure.dataset.title;
    part("choice-" + side).value = figure.id;
    for (const one of figures) {
      one.classList.toggle("is-" + side, one === figure);
      const button = one.querySelector("button[data-side=" + side + "]");
      if (button) button.setAttribute("aria-pressed", String(one === figure));
    }
  }

  function setWipe(share) {
    wipe.value = String(Math.round(Math.min(Math.max(share, 0), 1) * 1000));
    stage.style.setProperty("--wipe", wipe.value / 10 + "%");
  }

  function flip() {
    const a = sides.a;
    show("a", sides.b);
    show("b", a);
  }

  function wipeTo(event) {
    const box = stage.getBoundingClientRect();
    setWipe((event.clientX - box.left) / box.width);
  }

  for (const figure of figures) {
    const pick = document.createElement("span");
    pick.className = "pick";
    for (const side of ["a", "b"]) {
      const option = document.createElement("option");
      option.value = figure.id;
      option.textContent = figure.dataset.title;
      part("choice-" + side).append(option);

      const button = document.createElement("button");
      button.type = "button";
      button.dataset.side = side;
      button.textContent = side === "a" ? "Show left (A)" : "Show right (B)";
      button.addEventListener("click", () => show(side, figure));
      pick.append(button);
    }
    figure.querySelector("figcaption").append(pick);
    figure.querySelector("img.picture").addEventListener("click", () => {
      show("b", figure);
      compare.scrollIntoView({ block: "nearest" });
    });
  }

  for (const side of ["a", "b"])
    part("choice-" + side).addEventListener("change", (event) => show(side, document.getElementById(event.target.value)));
  wipe.addEventListener("input", () => setWipe(wipe.value / 1000));
  part("flip").addEventListener("click", flip);
  stage.addEventListener("pointerdown", (event) => {
    stage.setPointerCapture(event.pointerId);
    wipeTo(event);
  });
  stage.addEventListener("pointermove", (event) => {
    if (stage.hasPointerCapture(event.pointerId)) wipeTo(event);
  });
  document.addEventListener("keydown", (event) => {
    if (event.target.closest("a, button, select, input") || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "x") flip();
    else if (event.key === "[") setWipe(wipe.value / 1000 - 0.05);
    else if (event.key === "]") setWipe(wipe.value / 1000 + 0.05);
  });

  document.documentElement.classList.add("js");
  compare.hidden = false;
  show("a", document.getElementById("view-final") || figures[0]);
  show("b", document.getElementById("view-verdict") || figures[1]);
  setWipe(0.5);
})();
