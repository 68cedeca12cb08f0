/// Short names for what the API sends and takes (openapi.json; schema.d.ts is made from it).

import type { components, operations } from "./schema";

type Schemas = components["schemas"];

export type Job = Schemas["Job"];
export type JobList = Schemas["JobList"];
export type Status = Schemas["Status"];
export type Progress = Schemas["Progress"];
export type Phase = Progress["phase"];
export type Verdict = Schemas["Verdict"];
export type Mesh = Schemas["Mesh"];
export type BadFile = Schemas["BadFile"];
export type SetFile = Schemas["SetFile"];
export type Parts = Schemas["Parts"];
export type Info = Schemas["Info"];
export type Printer = Schemas["Printer"];
export type Option = Schemas["Option"];
export type Clearance = Schemas["Clearance"];
export type Start = Schemas["StartJob"];
/// Where a copy stands from now on; null: it is taken out.
export interface Change {
  readonly tray: number;
  readonly part: number;
  readonly copy: number;
  readonly transform: readonly (readonly number[])[] | null;
}
export type Unit = Schemas["Unit"];
/// How finely a mesh to look at is drawn.
export type Detail = NonNullable<NonNullable<operations["getMeshes"]["parameters"]["query"]>["detail"]>;

/// What `spectralpack pack --dry-run --json` says (docs/format.md); the schema names only what is always there.
export interface Estimate {
  readonly copies: number;
  readonly parts: number;
  readonly left_over?: number;
  readonly seconds: number | null;
  readonly memory: number;
  readonly memory_limit?: number;
  readonly volume_ratio?: number;
  readonly too_large?: readonly string[];
}

export type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };
export type JsonObject = { readonly [key: string]: Json };
