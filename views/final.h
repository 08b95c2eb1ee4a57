// The scene as it looks, with one glossy bounce a pixel.
#ifdef __cplusplus
{.name = "final",
 .title = "Final",
 .unit = "",
 .about = "The shaded scene; what its surfaces mirror was found by the grid's rays.",
 .scope = ViewScope::ray},
#else
ViewElement viewElement(uint pixel) { return colourElement(toneMapped(finalLight(pixel))); }
#endif
