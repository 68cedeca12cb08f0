/// Times and days as the page says them.

import { thin } from "./numbers";

/// How long: "0.3 s", "15 s", "5 min", "1 h 20 min".
export function duration(seconds: number): string {
  if (seconds < 9.95) return `${seconds.toFixed(1)}${thin}s`;
  if (seconds < 119.5) return `${Math.round(seconds)}${thin}s`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 60) return `${minutes}${thin}min`;
  const rest = minutes % 60;
  return `${Math.floor(minutes / 60)}${thin}h${rest ? ` ${rest}${thin}min` : ""}`;
}

/// A clock that runs: "0:09", "12:40", "1:02:03".
export function clock(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  const two = (value: number) => value.toString().padStart(2, "0");
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor(whole / 60) % 60;
  return hours ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}

const months = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];

export function dayAndMonth(date: Date): string {
  return `${date.getDate()} ${months[date.getMonth()] ?? ""}`;
}

export function timeOfDay(date: Date): string {
  return `${date.getHours().toString().padStart(2, "0")}:${date.getMinutes().toString().padStart(2, "0")}`;
}

/// When something was: "now", "14:31", "yesterday", "25 Nov", "25 Nov 2025".
export function ago(then: Date, now: Date): string {
  if (now.getTime() - then.getTime() < 60_000) return "now";
  const start = (date: Date) => new Date(date.getFullYear(), date.getMonth(), date.getDate()).getTime();
  const days = Math.round((start(now) - start(then)) / 86_400_000);
  if (days <= 0) return timeOfDay(then);
  if (days === 1) return "yesterday";
  const sameYear = then.getFullYear() === now.getFullYear() || days < 180;
  return sameYear ? dayAndMonth(then) : `${dayAndMonth(then)} ${then.getFullYear()}`;
}

/// A due date of a job file, "2026-12-02", as "2 Dec"; with its year where that is another one.
export function due(date: string, now: Date): string {
  const [year, month, day] = date.split("-").map(Number);
  if (!year || !month || !day) return date;
  const text = dayAndMonth(new Date(year, month - 1, day));
  return year === now.getFullYear() || Math.abs(month - 1 + 12 * (year - now.getFullYear()) - now.getMonth()) < 6
    ? text
    : `${text} ${year}`;
}
