// A picture of the gallery stands in no paragraph of its own: it gets one, in which it can be scrolled on narrow screens.
"use strict";
document.addEventListener("DOMContentLoaded", () => {
  for (const picture of document.querySelectorAll(".bd-article section > img")) {
    const paragraph = document.createElement("p");
    picture.replaceWith(paragraph);
    paragraph.append(picture);
  }
});
