// Choices of the user that the browser stores, if it allows it.

export function kept(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // a file may not be allowed to keep anything
  }
}

export function keep(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch {
    // The choice is then lost when the page is closed.
  }
}
