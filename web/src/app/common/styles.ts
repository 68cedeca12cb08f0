/// `<i ${styles({ width: "40%" })}>`: styles set by script. A style attribute, which Lit's own styleMap writes first,
/// would be refused by the server's Content-Security-Policy.

import { noChange } from "lit";
import { Directive, directive, type ElementPart, type PartInfo, PartType } from "lit/directive.js";

type Values = { readonly [property: string]: string | null };

class StylesDirective extends Directive {
  private before: Values = {};

  constructor(part: PartInfo) {
    super(part);
    if (part.type !== PartType.ELEMENT) throw new Error("styles() stands in a tag, not in an attribute");
  }

  override update(part: ElementPart, [values]: [Values]): unknown {
    const { style } = part.element as HTMLElement;
    for (const name of Object.keys(this.before)) if (!(name in values)) style.removeProperty(name);
    for (const [name, value] of Object.entries(values)) {
      if (value === this.before[name]) continue;
      if (value === null) style.removeProperty(name);
      else style.setProperty(name, value);
    }
    this.before = values;
    return noChange;
  }

  render(_values: Values): unknown {
    return noChange;
  }
}

export const styles = directive(StylesDirective);
